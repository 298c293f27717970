package rasterlab.engine.pipeline.fast;

/** Which triangles are left out by the way they turn on the picture. */
public enum Culling {
    NONE,
    /** Triangles that turn clockwise, seen from their inner side, are left out. */
    BACK,
    /** Triangles that turn counter-clockwise, seen from their outer side, are left out. */
    FRONT;

    /**
     * @param twiceArea positive where the corners run counter-clockwise on the picture
     */
    boolean keeps(long twiceArea) {
        if (twiceArea == 0) return false;
        return this == NONE || (this == BACK) == twiceArea > 0;
    }
}
