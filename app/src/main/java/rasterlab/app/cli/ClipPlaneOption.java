package rasterlab.app.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rasterlab.engine.visibility.ClipPlane;

/** Reads a plane A,B,C,D, of which what has Ax + By + Cz + D below 0 is cut off. */
final class ClipPlaneOption implements ITypeConverter<ClipPlane> {
    @Override
    public ClipPlane convert(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 4) throw noPlane(text);
        try {
            double[] p = new double[4];
            for (int i = 0; i < 4; i++) p[i] = Double.parseDouble(parts[i].strip());
            return new ClipPlane(p[0], p[1], p[2], p[3]);
        } catch (NumberFormatException e) {
            throw noPlane(text);
        } catch (IllegalArgumentException e) {
            throw new TypeConversionException("'%s': %s".formatted(text, e.getMessage()));
        }
    }

    private static TypeConversionException noPlane(String text) {
        return new TypeConversionException(
                "'" + text + "' is not a plane; expected four numbers A,B,C,D such as 1,0,0,-20");
    }
}
