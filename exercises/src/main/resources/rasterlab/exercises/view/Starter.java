import rasterlab.contract.EyeView;

/** Takes points to the space of an eye. So far every point stays as it is. */
public class MyView implements EyeView {
    @Override
    public void view(double theta, double phi, double rho, double[] points) {}
}
