package rasterlab.engine.transform.rotate;

/**
 * One task: points and how they turn.
 *
 * @param degrees the angle of one turn, counter-clockwise
 * @param times how many turns
 * @param points x, y one after the other
 */
public record Turns(double degrees, int times, double[] points) {
    public Turns {
        points = points.clone();
    }
}
