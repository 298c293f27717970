package rasterlab.app.cli.render;

import java.util.List;
import java.util.Optional;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rasterlab.engine.visibility.ClipPlane;

/**
 * Reads a plane A,B,C,D, of which what has Ax + By + Cz + D below 0 is cut off; or none, which
 * takes a scene file's planes back.
 */
final class ClipPlaneOption implements ITypeConverter<ClipPlaneOption.ClipPlaneValue> {
    /**
     * @param plane empty where nothing is cut off
     */
    record ClipPlaneValue(Optional<ClipPlane> plane) {}

    /**
     * The planes that are given one by one.
     *
     * @throws IllegalArgumentException for none beside others
     */
    static List<ClipPlane> planes(List<ClipPlaneValue> cuts) {
        List<ClipPlane> planes = cuts.stream().flatMap(cut -> cut.plane().stream()).toList();
        if (!planes.isEmpty() && planes.size() < cuts.size())
            throw new IllegalArgumentException("--clip-plane none must stand alone");
        return planes;
    }

    @Override
    public ClipPlaneValue convert(String text) {
        if (text.equals(LookOptions.NONE)) return new ClipPlaneValue(Optional.empty());
        String[] parts = text.split(",", -1);
        if (parts.length != 4) throw noPlane(text);
        try {
            double[] p = new double[4];
            for (int i = 0; i < 4; i++) p[i] = Double.parseDouble(parts[i].strip());
            return new ClipPlaneValue(Optional.of(new ClipPlane(p[0], p[1], p[2], p[3])));
        } catch (NumberFormatException e) {
            throw noPlane(text);
        } catch (IllegalArgumentException e) {
            throw new TypeConversionException("'%s': %s".formatted(text, e.getMessage()));
        }
    }

    private static TypeConversionException noPlane(String text) {
        return new TypeConversionException(
                "'"
                        + text
                        + "' is not a plane; expected four numbers A,B,C,D such as 1,0,0,-20, or none");
    }
}
