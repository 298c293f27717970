package rasterlab.exercises.score;

/**
 * Points of a submission.
 *
 * @param accuracy earned on cases
 * @param stability earned on hazards
 * @param speed earned against the reference methods in the same run
 * @param of the most that can be earned in all
 */
public record ScorePoints(int accuracy, int stability, int speed, int of) {
    public ScorePoints {
        if (accuracy < 0 || stability < 0 || speed < 0 || accuracy + stability + speed > of)
            throw new IllegalArgumentException(
                    "points must be at least 0 and at most "
                            + of
                            + " in all, got "
                            + accuracy
                            + " + "
                            + stability
                            + " + "
                            + speed);
    }

    public int total() {
        return accuracy + stability + speed;
    }
}
