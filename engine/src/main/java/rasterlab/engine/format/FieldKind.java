package rasterlab.engine.format;

/** The meaning of a field's value where inputs and answers are drawn. */
public enum FieldKind {
    /** Numbers in a table, which are not drawn. */
    NUMBERS,
    /** Pixels, each by its column and row. */
    PIXELS,
    /** Rows of characters, each character a pixel. */
    PICTURE,
    /** The pixel where a method begins. */
    SEED,
    /** Points, which are drawn where they have two coordinates. */
    POINTS,
    /** Segments, each by the coordinates of both ends. */
    SEGMENTS,
    /** The first end of one segment. */
    START,
    /** The last end of one segment. */
    END,
    /** The corners of a polygon. */
    POLYGON,
    /** Polygons, each by its corners. */
    POLYGONS,
    /** Triangles, each by three corner numbers of the given polygon. */
    TRIANGLES,
    /** A yes or no for each of the given points: whether it belongs to the answer. */
    CHOICE,
    /** A window by its least and greatest coordinates, or the corners of a convex polygon. */
    WINDOW,
    /** The centre of a circle or an ellipse. */
    CENTER,
    /** The radius of a circle, in all directions. */
    RADIUS,
    /** The half-axis of an ellipse along x. */
    RADIUS_X,
    /** The half-axis of an ellipse along y. */
    RADIUS_Y
}
