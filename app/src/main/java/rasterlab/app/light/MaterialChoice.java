package rasterlab.app.light;

import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.Substance;

/**
 * A material made from one of the known ones. The sliders end at {@link #MOST} and {@link
 * #SHINIEST}; the material of an opened input may lie beyond.
 *
 * @param substance what it is made from
 * @param ambient factor of its ambient shares; a share stays at most 1
 * @param diffuse factor of its diffuse shares
 * @param specular factor of its specular shares
 * @param emission light of its own, as a share of its diffuse colour
 * @param shininess exponent of its highlight
 */
public record MaterialChoice(
        Substance substance,
        double ambient,
        double diffuse,
        double specular,
        double emission,
        double shininess) {
    public static final double MOST = 2;

    public static final double SHINIEST = 200;

    public static MaterialChoice of(Substance substance) {
        return new MaterialChoice(substance, 1, 1, 1, 0, substance.surface().shininess());
    }

    public MaterialChoice withAmbient(double factor) {
        return new MaterialChoice(substance, factor, diffuse, specular, emission, shininess);
    }

    public MaterialChoice withDiffuse(double factor) {
        return new MaterialChoice(substance, ambient, factor, specular, emission, shininess);
    }

    public MaterialChoice withSpecular(double factor) {
        return new MaterialChoice(substance, ambient, diffuse, factor, emission, shininess);
    }

    public MaterialChoice withEmission(double share) {
        return new MaterialChoice(substance, ambient, diffuse, specular, share, shininess);
    }

    public MaterialChoice withShininess(double exponent) {
        return new MaterialChoice(substance, ambient, diffuse, specular, emission, exponent);
    }

    public Material material() {
        SurfaceMaterial whole = substance.surface();
        return new Material(
                new SurfaceMaterial(
                        times(whole.ambient(), ambient),
                        times(whole.diffuse(), diffuse),
                        times(whole.specular(), specular),
                        times(whole.diffuse(), emission),
                        shininess),
                1);
    }

    private static double[] times(double[] shares, double factor) {
        var scaled = new double[3];
        for (int c = 0; c < 3; c++) scaled[c] = Math.min(1, shares[c] * factor);
        return scaled;
    }
}
