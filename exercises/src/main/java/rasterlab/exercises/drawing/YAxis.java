package rasterlab.exercises.drawing;

/** The direction in which y grows. */
public enum YAxis {
    UP,
    DOWN
}
