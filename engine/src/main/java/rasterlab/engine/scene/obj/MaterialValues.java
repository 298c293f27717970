package rasterlab.engine.scene.obj;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A material while its file is read; where the file says nothing, the values here stay. */
final class MaterialValues {
    final String name;
    final String place;
    List<Double> ambient = gray(ReadingRules.AMBIENT);
    List<Double> diffuse = gray(ReadingRules.DIFFUSE);
    List<Double> specular = gray(ReadingRules.SPECULAR);
    List<Double> emitted = gray(ReadingRules.EMITTED);
    double shininess = ReadingRules.SHININESS.numberInstead();
    OptionalDouble opacity = OptionalDouble.empty();
    OptionalDouble transparency = OptionalDouble.empty();
    Optional<ObjMaterial.Map> diffuseMap = Optional.empty();
    int illumination = (int) ReadingRules.ILLUMINATION.numberInstead();

    /**
     * @param place the file and line of its {@code newmtl}; "" where it is in no file
     */
    MaterialValues(String name, String place) {
        this.name = name;
        this.place = place;
    }

    private static List<Double> gray(Rule rule) {
        double level = rule.numberInstead();
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
                opacity.orElse(1 - transparency.orElse(0)),
                diffuseMap,
                illumination);
    }
}
