"""Samples, intervals, curves and saturation: plain numbers, nothing of YADE."""
