package rasterlab.engine.scene.obj;

import java.util.List;
import java.util.Optional;

/** A material while its file is read; where the file says nothing, the values here stay. */
final class MaterialValues {
    final String name;
    List<Double> ambient = grey(0.2);
    List<Double> diffuse = grey(0.8);
    List<Double> specular = grey(0);
    List<Double> emitted = grey(0);
    double shininess;
    double opacity = 1;
    Optional<ObjMaterial.Map> diffuseMap = Optional.empty();
    int illumination = 2;

    MaterialValues(String name) {
        this.name = name;
    }

    private static List<Double> grey(double level) {
        return List.of(level, level, level);
    }

    ObjMaterial material() {
        return new ObjMaterial(
                name,
                ambient,
                diffuse,
                specular,
                emitted,
                shininess,
                opacity,
                diffuseMap,
                illumination);
    }
}
