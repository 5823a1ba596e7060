"""Constants of the elastoplastic contact law from finite elements: material files, the model of two bodies in contact, the fit.

After Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39, 1211 (2018), section 1; numbers in round brackets are its equations.
Only `body` and what builds on it need getfem; material files (`materialfile`), closed forms (`hertz`) and the fit (`fit`) do not.
"""
