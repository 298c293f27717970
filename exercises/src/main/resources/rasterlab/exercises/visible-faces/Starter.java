import rasterlab.contract.VisibleFaces;

/** Tells which faces are turned towards the eye. So far it knows of none. */
public class MyFaces implements VisibleFaces {
    @Override
    public boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
        return new boolean[0];
    }
}
