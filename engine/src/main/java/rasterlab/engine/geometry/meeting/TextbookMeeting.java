package rasterlab.engine.geometry.meeting;

import rasterlab.contract.LinePlane;

/**
 * The course's formula as it stands: μ = (c − n·p₁) / (n·p*), p* = p₂ − p₁.
 *
 * <p>Along a parallel line n·p* is 0 and μ no number, which nothing here asks about; where products
 * leave the range of doubles, it is rubbish.
 */
final class TextbookMeeting implements LinePlane {
    @Override
    public double meets(double[] normal, double c, double[] from, double[] through) {
        double slope =
                normal[0] * (through[0] - from[0])
                        + normal[1] * (through[1] - from[1])
                        + normal[2] * (through[2] - from[2]);
        double rise = c - (normal[0] * from[0] + normal[1] * from[1] + normal[2] * from[2]);
        return rise / slope;
    }
}
