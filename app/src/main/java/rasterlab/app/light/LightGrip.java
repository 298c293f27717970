package rasterlab.app.light;

/**
 * Something on the pictures that can be dragged.
 *
 * @param kind what it is
 * @param index of the lamp; 0 for the others
 */
record LightGrip(Kind kind, int index) {
    /** What can be dragged. */
    enum Kind {
        LAMP,
        FROM,
        TO,
        POINT
    }
}
