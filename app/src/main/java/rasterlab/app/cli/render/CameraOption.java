package rasterlab.app.cli.render;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rasterlab.engine.transform.SphericalView;
import rasterlab.exercises.scene.SceneSetting;

/**
 * Reads a camera θ,φ,ρ: two angles in radians, also as multiples such as 0.25pi, and a distance.
 */
final class CameraOption implements ITypeConverter<SphericalView> {
    @Override
    public SphericalView convert(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 3)
            throw new TypeConversionException(
                    "'" + text + "' is not a camera; expected theta,phi,rho such as 0.7,1.2,900");
        try {
            return new SphericalView(angle(parts[0]), angle(parts[1]), number(parts[2]));
        } catch (IllegalArgumentException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

    private static double angle(String text) {
        String number = text.strip().replaceFirst("(pi|π)$", "");
        boolean multiple = number.length() < text.strip().length();
        double radians = multiple ? number(number) * Math.PI : number(number);
        if (Math.abs(radians) > SceneSetting.MOST_RADIANS)
            throw new TypeConversionException(
                    "angle must be from %s to %s radians, got '%s'"
                            .formatted(
                                    -SceneSetting.MOST_RADIANS, SceneSetting.MOST_RADIANS, text));
        return radians;
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text.strip());
        } catch (NumberFormatException e) {
            throw new TypeConversionException(
                    "'" + text + "' is not a number; expected theta,phi,rho such as 0.7,0.4pi,900");
        }
    }
}
