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
        double sum = 0;
        for (int i = 0; i < polygon.length; i++) {
            double mean = 0;
            if (i < 3) {
                for (int k = i; k < polygon.length; k += 3) mean += 3 * polygon[k] / polygon.length;
                sum += (mean - eye[i]) * (mean - eye[i]);
            }
        }
        return Math.sqrt(sum);
    }
}
