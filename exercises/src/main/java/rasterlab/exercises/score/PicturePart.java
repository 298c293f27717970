package rasterlab.exercises.score;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.exercises.document.OwnJson;

/**
 * Which pixels a case's picture shows.
 *
 * @param shown the columns and rows of the picture
 * @param whole those of all that is expected or drawn
 * @param pixel the one that the case's message names, or another that a smaller part is to show
 */
public record PicturePart(PixelWindow shown, PixelWindow whole, Pixel pixel) {
    /** Whether nothing is left out. */
    public boolean isWhole() {
        return shown.equals(whole);
    }

    /**
     * The part of at most so many columns and rows of what is shown, with the pixel in their
     * middle.
     */
    public PicturePart around(int columns, int rows) {
        return new PicturePart(shown.around(pixel.x(), pixel.y(), columns, rows), whole, pixel);
    }

    /** The rows of characters of {@link CasePicture#text}, without the line on the part. */
    public List<String> rows(String text) {
        return text.lines().skip(isWhole() ? 0 : 1).toList();
    }

    /** The part in words: its first and last column, those of the whole, and its rows. */
    public Message message() {
        return Message.of(
                "picture.part",
                shown.xmin(),
                shown.xmax(),
                whole.xmin(),
                whole.xmax(),
                shown.ymin(),
                shown.ymax(),
                whole.ymin(),
                whole.ymax());
    }

    /** The part as JSON, to be stored and for scripts. */
    public String data() {
        try {
            return OwnJson.MAPPER.writeValueAsString(this);
        } catch (JsonProcessingException e) {
            throw new AssertionError("numbers can always be written", e);
        }
    }

    /** Reads back the text that {@link #data} wrote; empty where it is nothing of that form. */
    public static Optional<PicturePart> ofData(String data) {
        try {
            return Optional.ofNullable(OwnJson.MAPPER.readValue(data, PicturePart.class));
        } catch (JsonProcessingException e) {
            return Optional.empty();
        }
    }
}
