package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.drawing.PixelPictures;
import rasterlab.exercises.pixels.PixelOrder;
import rasterlab.exercises.score.CasePicture;

/**
 * Draws the pixels of an answer as a grid: those it lists, or those of a picture that are not as
 * they were given.
 */
final class FormPixels {
    private final FormFields fields;

    FormPixels(FormFields fields) {
        this.fields = fields;
    }

    /**
     * The pictures of two answers; none where they have no pixels, or the same ones. Where none is
     * missing or extra, those that come again are shown, or those out of turn.
     */
    List<CasePicture> pictures(JsonNode exact, JsonNode actual) {
        PixelRecording right = pixels(exact);
        PixelRecording mine = pixels(actual);
        PixelDifference difference = PixelDifference.of(right, mine);
        PixelSet misplaced = PixelSet.of(new PixelOrder(right, mine).misplaced(difference));
        PixelSet again = misplaced.filter(difference.right()::contains);
        return Stream.of(difference.missing(), difference.extra(), again)
                .filter(set -> !set.isEmpty())
                .findFirst()
                .map(set -> PixelPictures.of(difference, again, new Pixel(set.x(0), set.y(0))))
                .orElse(List.of());
    }

    /** The pixels of an answer, each once. */
    PixelSet lit(JsonNode answer) {
        return PixelSet.of(pixels(answer));
    }

    private PixelRecording pixels(JsonNode answer) {
        var recording = new PixelRecording(Integer.MAX_VALUE);
        for (JsonNode all : fields.answered(answer, FieldKind.PIXELS))
            for (JsonNode one : all) recording.plot(one.get(0).asInt(), one.get(1).asInt());
        JsonNode given = fields.one(FieldKind.PICTURE);
        for (JsonNode picture : fields.answered(answer, FieldKind.PICTURE))
            for (int y = 0; y < Math.min(given.size(), picture.size()); y++)
                plotChanged(y, given.get(y).asText(), picture.get(y).asText(), recording);
        return recording;
    }

    private static void plotChanged(int y, String before, String after, PixelRecording into) {
        for (int x = 0; x < Math.min(before.length(), after.length()); x++)
            if (before.charAt(x) != after.charAt(x)) into.plot(x, y);
    }
}
