package rasterlab.exercises.score;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Which part of a picture a text of {@link CasePictures} shows, where it is not all of it.
 *
 * @param columns first and last of the part, then those of the whole picture
 * @param rows the same
 */
public record PicturePart(List<Integer> columns, List<Integer> rows) {
    private static final String RANGE = "(-?\\d+)\\.\\.(-?\\d+) of (-?\\d+)\\.\\.(-?\\d+)";
    private static final Pattern LINE = Pattern.compile("columns " + RANGE + ", rows " + RANGE);

    /**
     * What the first line says; empty where the text shows the whole picture.
     *
     * @param text as {@link CasePictures#text}
     */
    public static Optional<PicturePart> of(String text) {
        Matcher line = LINE.matcher(text.lines().findFirst().orElse(""));
        if (!line.matches()) return Optional.empty();
        try {
            return Optional.of(new PicturePart(numbers(line, 1), numbers(line, 5)));
        } catch (NumberFormatException fromAnotherServer) {
            return Optional.empty();
        }
    }

    private static List<Integer> numbers(Matcher line, int first) {
        return List.of(
                Integer.valueOf(line.group(first)),
                Integer.valueOf(line.group(first + 1)),
                Integer.valueOf(line.group(first + 2)),
                Integer.valueOf(line.group(first + 3)));
    }

    /** The rows of characters alone. */
    public static List<String> rows(String text) {
        return text.lines().skip(of(text).isPresent() ? 1 : 0).toList();
    }

    /** Columns of the whole picture. */
    public long width() {
        return size(columns);
    }

    /** Rows of the whole picture. */
    public long height() {
        return size(rows);
    }

    private static long size(List<Integer> range) {
        return (long) range.get(3) - range.get(2) + 1;
    }

    /** The line in words. */
    public Message said() {
        return Message.of("picture.part", Stream.concat(columns.stream(), rows.stream()).toArray());
    }
}
