package rasterlab.exercises;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.score.Phrase;

/** A picture of a statement, in its file's own form. */
public final class Picture {
    /** What a picture's file can be. */
    public enum Form {
        PNG("image/png"),
        SVG("image/svg+xml");

        private final String mediaType;

        Form(String mediaType) {
            this.mediaType = mediaType;
        }

        public String mediaType() {
            return mediaType;
        }

        private String ending() {
            return "." + name().toLowerCase(java.util.Locale.ROOT);
        }

        /** The form that a file's name tells; empty for another one. */
        static Optional<Form> of(String file) {
            return Stream.of(values()).filter(form -> file.endsWith(form.ending())).findFirst();
        }

        private boolean begins(byte[] content) {
            if (this == PNG)
                return content.length > PNG_SIGNATURE.length
                        && Arrays.equals(
                                Arrays.copyOf(content, PNG_SIGNATURE.length), PNG_SIGNATURE);
            return new String(content, StandardCharsets.UTF_8).contains("<svg");
        }
    }

    private static final byte[] PNG_SIGNATURE = {
        (byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'
    };

    private final Form form;
    private final byte[] content;

    private Picture(Form form, byte[] content) {
        this.form = form;
        this.content = content.clone();
    }

    /** The endings of files that can be pictures. */
    public static List<String> endings() {
        return Stream.of(Form.values()).map(Form::ending).toList();
    }

    /**
     * @param file its name, which tells its form
     * @throws CatalogueException if the name or the content is of no known form
     */
    public static Picture of(String file, byte[] content) {
        Form form =
                Form.of(file)
                        .orElseThrow(
                                () ->
                                        new CatalogueException(
                                                Phrase.of(
                                                        "picture.ending",
                                                        String.join(", ", endings()),
                                                        file)));
        if (!form.begins(content))
            throw new CatalogueException(Phrase.of("picture.form", file, form));
        return new Picture(form, content);
    }

    public Form form() {
        return form;
    }

    /** A copy of the file. */
    public byte[] content() {
        return content.clone();
    }
}
