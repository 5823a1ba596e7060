"""The version of plugin and package."""
__version__ = '0.1.0'
