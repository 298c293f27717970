package rasterlab.exercises.score;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * A picture of a case.
 *
 * @param kind such as {@link #DIFFERENCE}, in lower-case words with hyphens; a reader shows one
 *     that it does not know under this name
 * @param file the picture as PNG
 * @param text tells what is there to people who do not see it; of a grid of pixels its rows of
 *     characters, below a line on the part where they are not all
 * @param part which pixels of a grid these are; empty where it is no grid, and where an older
 *     version made it
 */
public record CasePicture(
        String kind, PictureBytes file, Message text, Optional<PicturePart> part) {
    public static final String EXPECTED = "expected";
    public static final String ACTUAL = "actual";

    /** Missing, extra and right told apart by shape and colour. */
    public static final String DIFFERENCE = "difference";

    private static final Pattern KIND = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*");

    public CasePicture {
        if (!isKind(kind))
            throw new IllegalArgumentException(
                    "a picture's kind is lower-case words with hyphens, got '" + kind + "'");
    }

    /** A picture that is the same in each language. */
    public CasePicture(String kind, byte[] png, Message text, Optional<PicturePart> part) {
        this(kind, PictureBytes.alike(png), text, part);
    }

    /** The PNG with numbers as English writes them. */
    public byte[] png() {
        return png("en");
    }

    /**
     * The PNG with numbers as that language writes them.
     *
     * @param language such as "ru"
     */
    public byte[] png(String language) {
        return file.in(language);
    }

    /** Whether a picture can be called so, as a part of an address or of a file's name too. */
    public static boolean isKind(String name) {
        return KIND.matcher(name).matches();
    }

    /** The one of that kind; empty where there is none. */
    public static Optional<CasePicture> of(List<CasePicture> pictures, String kind) {
        return pictures.stream().filter(one -> one.kind.equals(kind)).findFirst();
    }
}
