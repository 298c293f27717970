package rasterlab.engine.scene;

import java.util.Optional;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.Material;

/**
 * The look of the faces of a mesh.
 *
 * @param front the material of outer sides
 * @param back the material of inner sides
 * @param texture what lies on both
 */
public record Appearance(Material front, Material back, Optional<LaidTexture> texture) {

    /** A finish that is opaque and dull on both sides. */
    public static Appearance dull(int rgb) {
        return of(
                Material.dull(
                        (rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0));
    }

    /** One material on both sides. */
    public static Appearance of(Material material) {
        return new Appearance(material, material, Optional.empty());
    }

    public Appearance with(LaidTexture laid) {
        return new Appearance(front, back, Optional.of(laid));
    }

    /** The diffuse colour of the front, 0xRRGGBB. */
    public int rgb() {
        double[] diffuse = front.surface().diffuse();
        return Levels.argb(diffuse[0], diffuse[1], diffuse[2], 1) & 0xFFFFFF;
    }
}
