import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

/** Writes a colour in another model. So far every number is 0. */
public class MyColors implements ColorConverter {
    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        return new double[to.size()];
    }
}
