package rasterlab.app.exercise;

/**
 * The user's choice, as it is kept between runs.
 *
 * @param exercise its id; "" before one was shown
 * @param typeSteps by how much the editor's type is larger than the window's, in points
 */
public record ExerciseChoice(String exercise, int typeSteps) {
    static final ExerciseChoice FIRST = new ExerciseChoice("", 0);

    /** Smaller type cannot be read, larger type leaves no room for a line. */
    private static final int SMALLEST = -4;

    private static final int LARGEST = 24;

    public ExerciseChoice {
        if (typeSteps < SMALLEST || typeSteps > LARGEST)
            throw new IllegalArgumentException(
                    "typeSteps must be from %d to %d points, got %d"
                            .formatted(SMALLEST, LARGEST, typeSteps));
    }

    ExerciseChoice with(String other) {
        return new ExerciseChoice(other, typeSteps);
    }

    /** The choice with larger type, or smaller; stops at the ends of the range. */
    ExerciseChoice grown(int points) {
        int next = Math.max(SMALLEST, Math.min(LARGEST, typeSteps + points));
        return new ExerciseChoice(exercise, next);
    }
}
