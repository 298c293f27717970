package rasterlab.app.cli.render;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rasterlab.engine.pipeline.Stereo;

/** Reads the distance of two eyes: world units such as 30, or an angle such as 3deg. */
final class EyesOption implements ITypeConverter<EyesOption.Distance> {

    /**
     * @param number in world units or degrees
     */
    record Distance(double number, boolean degrees) {
        double units(double rho) {
            return degrees ? Stereo.separationAt(number, rho) : number;
        }
    }

    @Override
    public Distance convert(String text) {
        boolean degrees = text.endsWith("deg");
        String number = degrees ? text.substring(0, text.length() - 3) : text;
        try {
            return above0(new Distance(Double.parseDouble(number), degrees), text);
        } catch (NumberFormatException e) {
            throw new TypeConversionException(
                    "'"
                            + text
                            + "' is not a distance; expected world units such as 30 or an angle such"
                            + " as 3deg");
        }
    }

    private static Distance above0(Distance distance, String text) {
        if (!(distance.number > 0))
            throw new TypeConversionException("distance must be above 0, got '" + text + "'");
        return distance;
    }
}
