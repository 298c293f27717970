package rasterlab.exercises;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.score.PictureBytes;

/** A picture of a statement: a file as it is, or one that is drawn by what a file tells. */
public final class StatementPicture {
    /** The formats that a picture's file can have. */
    public enum PictureFormat {
        PNG("image/png"),
        SVG("image/svg+xml");

        private final String mediaType;

        PictureFormat(String mediaType) {
            this.mediaType = mediaType;
        }

        public String mediaType() {
            return mediaType;
        }

        private String ending() {
            return "." + name().toLowerCase(java.util.Locale.ROOT);
        }

        /** The form that a file's name tells; empty for another one. */
        static Optional<PictureFormat> of(String file) {
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

    private final PictureFormat form;
    private final String file;
    private final byte[] kept;
    private final Supplier<PictureBytes> content;

    private StatementPicture(
            PictureFormat form, String file, byte[] kept, Supplier<PictureBytes> content) {
        this.form = form;
        this.file = file;
        this.kept = kept;
        this.content = content;
    }

    /**
     * A picture that is drawn when it is asked for first.
     *
     * @param file name of the file that tells what is drawn
     * @param kept its content
     * @param png draws it, in each language
     */
    public static StatementPicture drawn(String file, byte[] kept, Supplier<PictureBytes> png) {
        return new StatementPicture(PictureFormat.PNG, file, kept.clone(), new Once(png));
    }

    /** The endings of files that can be pictures. */
    public static List<String> endings() {
        return Stream.of(PictureFormat.values()).map(PictureFormat::ending).toList();
    }

    /**
     * @param file its name, which tells its form
     * @throws CatalogueException if the name or the content is of no known form
     */
    public static StatementPicture of(String file, byte[] content) {
        PictureFormat form =
                PictureFormat.of(file)
                        .orElseThrow(
                                () ->
                                        new CatalogueException(
                                                Phrase.of(
                                                        "picture.ending",
                                                        String.join(", ", endings()),
                                                        file)));
        if (!form.begins(content))
            throw new CatalogueException(Phrase.of("picture.form", file, form));
        byte[] own = content.clone();
        return new StatementPicture(form, file, own, () -> PictureBytes.alike(own));
    }

    public PictureFormat form() {
        return form;
    }

    /**
     * A copy of what is shown.
     *
     * @param language in which the picture's numbers are written, such as "ru"
     */
    public byte[] content(String language) {
        return content.get().in(language);
    }

    /** Name of the file in the exercise's folder that it comes from. */
    public String file() {
        return file;
    }

    /** A copy of that file. */
    public byte[] kept() {
        return kept.clone();
    }

    private static final class Once implements Supplier<PictureBytes> {
        private final Supplier<PictureBytes> make;
        private PictureBytes made;

        Once(Supplier<PictureBytes> make) {
            this.make = make;
        }

        @Override
        public synchronized PictureBytes get() {
            if (made == null) made = make.get();
            return made;
        }
    }
}
