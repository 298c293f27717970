package rasterlab.app.polygon.outcome;

/** The product of a method, with the steps on the way. */
sealed interface PolygonAnswer permits InsideAnswer, CutAnswer, PixelAnswer {
    /** How many steps can be looked at. */
    int steps();
}
