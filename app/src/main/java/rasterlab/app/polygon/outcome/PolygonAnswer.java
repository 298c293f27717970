package rasterlab.app.polygon.outcome;

/** What a method produced, and the steps on the way. */
sealed interface PolygonAnswer permits InsideAnswer, CutAnswer, PixelAnswer {
    /** How many steps can be looked at. */
    int steps();
}
