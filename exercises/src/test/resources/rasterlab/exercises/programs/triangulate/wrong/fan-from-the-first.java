import rasterlab.contract.Triangulator;

public class FanOfTriangles implements Triangulator {
    @Override
    public int[] triangulate(double[] x, double[] y) {
        int[] answer = new int[3 * (x.length - 2)];
        int at = 0;
        for (int i = 1; i + 1 < x.length; i++) {
            answer[at++] = 0;
            answer[at++] = i;
            answer[at++] = i + 1;
        }
        return answer;
    }
}
