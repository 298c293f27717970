package rasterlab.app.cli.render;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rasterlab.engine.raster.Raster;

/** A picture's size in pixels, as large as pictures may be. */
record PictureSize(int width, int height) {
    PictureSize {
        Raster.checkSize(width, height);
    }

    /** Reads sizes such as 800x600. */
    static final class Reader implements ITypeConverter<PictureSize> {
        private static final Pattern FORM = Pattern.compile("(\\d{1,6})[x×](\\d{1,6})");

        @Override
        public PictureSize convert(String text) {
            Matcher size = FORM.matcher(text);
            if (!size.matches())
                throw new TypeConversionException(
                        "'%s' is not a size; expected WIDTHxHEIGHT, 1x1 to %dx%d, such as 800x600"
                                .formatted(text, Raster.LARGEST_SIDE, Raster.LARGEST_SIDE));
            try {
                return new PictureSize(
                        Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2)));
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(e.getMessage());
            }
        }
    }
}
