package rasterlab.engine.light.face;

import java.util.ArrayList;
import rasterlab.contract.LitFace;

/**
 * Points of a face to shade.
 *
 * @param weights three of each point
 */
public record FacePoints(LitFace face, double[] weights) {
    public FacePoints {
        FacePoint.requireWeights(weights);
        weights = weights.clone();
    }

    /** The points of a regular grid, (rows + 1)·(rows + 2)/2 of them, the corners included. */
    public static FacePoints grid(LitFace face, int rows) {
        var weights = new ArrayList<Double>();
        for (int i = 0; i <= rows; i++)
            for (int j = 0; j <= rows - i; j++) {
                weights.add(i / (double) rows);
                weights.add(j / (double) rows);
                weights.add((rows - i - j) / (double) rows);
            }
        return new FacePoints(face, weights.stream().mapToDouble(Double::doubleValue).toArray());
    }

    public int count() {
        return weights.length / 3;
    }
}
