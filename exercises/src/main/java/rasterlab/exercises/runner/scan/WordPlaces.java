package rasterlab.exercises.runner.scan;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/** Where some words stand in a source, found in one pass; of each line the first place counts. */
final class WordPlaces {
    /** The column, from 1, by word and then by line. */
    private final Map<String, Map<Integer, Integer>> columns = new HashMap<>();

    private final Map<String, Integer> firstLines = new HashMap<>();

    private WordPlaces() {}

    /**
     * @param lines whose words matter beside the first place of each
     */
    static WordPlaces in(String source, Set<String> words, Set<Integer> lines) {
        WordPlaces places = new WordPlaces();
        SourceWords read = new SourceWords(source);
        while (read.next())
            for (String word : words)
                if (read.is(word)
                        && (lines.contains(read.line()) || !places.firstLines.containsKey(word)))
                    places.add(word, read.line(), read.column());
        return places;
    }

    private void add(String word, int line, int column) {
        firstLines.putIfAbsent(word, line);
        columns.computeIfAbsent(word, one -> new HashMap<>()).putIfAbsent(line, column);
    }

    /** The first line in which the word stands; 0 where there is none. */
    int firstLine(String word) {
        return firstLines.getOrDefault(word, 0);
    }

    /** Where the word stands first in one of the lines that matter; 0 where it does not. */
    int column(String word, int line) {
        return columns.getOrDefault(word, Map.of()).getOrDefault(line, 0);
    }
}
