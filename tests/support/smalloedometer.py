"""The smallest oedometer test in which particles break: parameters for test_oedometer.py and test_study_oedometer.py."""
SMALL = dict(particles=25, containerWidth=0.09, young=2e7, characteristicStrength=3e4, maxStress=8e4, seatingStress=1e3, maxStrain=0.2, strainRate=3,
             inertialNumber=0.05, sampleStrain=2e-3, maxSettlingTime=0.5)
