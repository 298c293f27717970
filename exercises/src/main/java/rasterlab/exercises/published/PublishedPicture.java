package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PicturePart;
import rasterlab.exercises.score.PixelRows;

/**
 * A case's picture.
 *
 * @param kind of the picture; whoever does not know it shows the picture under this name
 * @param url where the PNG is
 * @param text tells people who do not see it what is there, in their language; of a grid of pixels
 *     its rows
 * @param textInJson the same as JSON has it
 * @param part which pixels of a grid these are; empty where it is no grid, and where an older
 *     server drew it
 */
public record PublishedPicture(
        String kind, String url, String text, String textInJson, Optional<PicturePart> part)
        implements PublishedPart {
    /**
     * A picture in words of that language.
     *
     * @param language such as "ru"
     */
    public static PublishedPicture of(CasePicture picture, String language, String url) {
        return new PublishedPicture(
                picture.kind(),
                url,
                picture.text().in(language),
                picture.text().inJson(language),
                picture.part());
    }

    /** The rows of characters alone; none where it is no grid of pixels. */
    public List<String> rows() {
        return PixelRows.of(text, part);
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeStringField("kind", kind);
        out.writeStringField("url", url);
        out.writeStringField("text", textInJson);
        out.writeFieldName("part");
        if (part.isPresent()) out.writeRawValue(part.get().data());
        else out.writeNull();
        out.writeEndObject();
    }
}
