"""Pour a bed into the cache: yade -n -x pourbed.py KIND COUNT. See beds.py, levelset.py and bedcache.py."""
import sys

import beds
import levelset
import machine
from bedcache import bedFile

kind, count = sys.argv[1], int(sys.argv[2])
bed = levelset.pour(count) if kind == 'levelSet' else beds.pour(kind, count)
bed.facts['commit'] = machine.commit()  # whose solver met what the facts tell
bed.save(bedFile(kind, count))
