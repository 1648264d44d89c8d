"""Cracks a plate through the installed package: fails where there are no cracks."""

import craze

result = craze.crack(craze.shape("plate?n=20"), "mud", max_cracks=5)
assert len(result.lines.edges) > 0
assert len(result.mesh.faces) > len(craze.shape("plate?n=20").faces)
