import java.util.Arrays;
import java.util.Comparator;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;

public class ByDepth implements DepthOrder {
    @Override
    public void order(double[][] polygons, double[] eye, PieceSink out) {
        Integer[] order = new Integer[polygons.length];
        Arrays.setAll(order, k -> k);
        Arrays.sort(order, Comparator.comparingDouble(k -> -depth(polygons[k], eye)));
        for (int k : order) out.piece(k, polygons[k]);
    }

    private static double depth(double[] polygon, double[] eye) {
        double least = Double.MAX_VALUE;
        for (int k = 0; k < polygon.length; k += 3)
            least = Math.min(least, Math.hypot(Math.hypot(polygon[k] - eye[0], polygon[k + 1] - eye[1]), polygon[k + 2] - eye[2]));
        return least;
    }
}
