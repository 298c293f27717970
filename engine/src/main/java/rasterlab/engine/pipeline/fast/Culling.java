package rasterlab.engine.pipeline.fast;

/** Which triangles are left out by the way they turn on the picture. */
public enum Culling {
    NONE,
    /** What turns clockwise, seen from its inner side, is left out. */
    BACK,
    /** What turns counter-clockwise, seen from its outer side, is left out. */
    FRONT;

    /**
     * @param twiceArea positive where the corners run counter-clockwise on the picture
     */
    boolean keeps(long twiceArea) {
        if (twiceArea == 0) return false;
        return this == NONE || (this == BACK) == twiceArea > 0;
    }
}
