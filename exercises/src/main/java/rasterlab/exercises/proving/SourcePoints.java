package rasterlab.exercises.proving;

import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Points;

/**
 * What the judge gives to a source of the exercise's folder.
 *
 * @param points 0 where the source is not accepted
 * @param why what the compiler or the checks say; empty where it is accepted
 */
public record SourcePoints(GradingVerdict verdict, Points points, String why) {
    int withoutSpeed() {
        return points.accuracy() + points.stability();
    }
}
