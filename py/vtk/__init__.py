"""Series of files for ParaView, written and read back."""
