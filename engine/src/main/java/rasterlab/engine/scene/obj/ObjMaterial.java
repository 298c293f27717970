package rasterlab.engine.scene.obj;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.range.Bounds;

/**
 * How the faces of a model look. Colours are red, green and blue, 0 to 1 unless a light shines
 * through {@code emitted}.
 *
 * @param name as in the file
 * @param ambient Ka
 * @param diffuse Kd
 * @param specular Ks
 * @param emitted Ke, at least 0
 * @param shininess Ns, the exponent of the highlight, 0 to 1000
 * @param opacity d, or 1 − Tr: 0 is transparent, 1 opaque
 * @param diffuseMap map_Kd
 * @param illumination illum, the lighting model's number, 0 to 10
 */
public record ObjMaterial(
        String name,
        List<Double> ambient,
        List<Double> diffuse,
        List<Double> specular,
        List<Double> emitted,
        double shininess,
        double opacity,
        Optional<Map> diffuseMap,
        int illumination) {
    /**
     * A texture, which stands at {@code s · scale + offset} of its picture, and t likewise.
     *
     * @param names its file's, the likeliest first: as the material has it, then without what may
     *     be an option's word or a comment
     * @param place the material file and the line that name it, for messages
     * @param offset along s and t
     * @param scale along s and t
     * @param clamped whether its outermost texels go on instead of the picture again
     */
    public record Map(
            List<String> names,
            String place,
            List<Double> offset,
            List<Double> scale,
            boolean clamped) {
        public Map {
            names = List.copyOf(names);
            offset = List.copyOf(offset);
            scale = List.copyOf(scale);
        }
    }

    public ObjMaterial {
        Bounds.require("shininess", shininess, 0, 1000);
        Bounds.require("illumination", illumination, 0, 10);
        ambient = List.copyOf(ambient);
        diffuse = List.copyOf(diffuse);
        specular = List.copyOf(specular);
        emitted = List.copyOf(emitted);
    }

    /** The material of faces whose own is missing: light grey without a highlight. */
    static ObjMaterial standard(String name) {
        return new MaterialValues(name, "").material();
    }

    ObjMaterial opaque() {
        return new ObjMaterial(
                name, ambient, diffuse, specular, emitted, shininess, 1, diffuseMap, illumination);
    }
}
