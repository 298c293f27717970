import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

/** Shades points of a face. So far all of them are black. */
public class MyShading implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        return new double[weights.length];
    }
}
