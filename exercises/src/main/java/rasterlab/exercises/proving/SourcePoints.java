package rasterlab.exercises.proving;

import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.ScorePoints;

/**
 * The points that the judge gives to a source of the exercise's folder.
 *
 * @param points 0 where the source is not accepted
 * @param why what the compiler or the checks say; empty where it is accepted
 * @param untimed why its speed cannot be measured; nothing where it can, or nobody tried
 * @param timed whether its speed was measured, or is worth nothing
 */
public record SourcePoints(
        GradingVerdict verdict, ScorePoints points, String why, Message untimed, boolean timed) {
    int withoutSpeed() {
        return points.accuracy() + points.stability();
    }
}
