package rasterlab.engine.lanes;

import jdk.incubator.vector.FloatVector;

/** What the Vector API says of this machine. */
final class WidestVectorHere implements Lanes.WidestVector {
    @Override
    public int bits() {
        return FloatVector.SPECIES_PREFERRED.vectorBitSize();
    }
}
