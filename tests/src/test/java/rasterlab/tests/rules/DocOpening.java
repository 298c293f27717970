package rasterlab.tests.rules;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import rasterlab.tests.Repository;

/**
 * The first sentence of a doc comment, which says what the thing is or does.
 *
 * <p>It begins with a noun or a verb: "Scrolls to the result.", "The radius, in pixels.", "Whether
 * the point lies inside." Words that lean on something unsaid make a fragment of it: "Of the plane
 * 2, of space 3.", "Empty where there is none.", "They touch.", "Pixels.", "What was done last.",
 * "The same with another look.", "Another look."
 *
 * @param place file and line of the comment
 */
record DocOpening(String place, String sentence) {
    /** Words that no first sentence begins with, most of them prepositions and pronouns. */
    private static final String LEANING =
            "Of For In At By With As To And But Or So On From Between Without Below Above Under"
                    + " Beneath Beside Behind Beyond Around After Before While Until Because If"
                    + " Though Although Also Otherwise Than Among Within Up Down Not Neither Either"
                    + " Inside Outside Out Off Over Through Across Along Against Into Onto Upon"
                    + " Since Unless Unlike Like Despite During Past Per Apart Away Further Else"
                    + " Then Therefore Thus Hence However Yet Still Again Often Once Just"
                    + " Even Too Rather Instead Together Backwards Forwards Upwards Downwards"
                    + " Midway Strictly Infinitely Evenly Exactly Towards Except Whereas It Its"
                    + " They Their Them Those Such He She What Whatever Whoever Likewise Any"
                    + " Another";

    /** Words without a noun of their own, where one of {@link #AFTER} or a stop follows. */
    private static final String BARE =
            "[A-Z]\\w*ed|[A-Z]\\w*en|Told|Made|Lit|Drawn|Shown|Known|Cut|Set|Held|Kept|Read|Sent"
                    + "|Empty|Right|Wrong|Longer|Shorter|More|Less|Larger|Smaller|Wider|Narrower"
                    + "|Higher|Lower|Whole|Opaque|Nothing|None|Null|Small|Large|Slow|Fast|True"
                    + "|False|Same|Flat|Equal|Open|Wide|Nobody|Back|Near|Nearer|That|These|There"
                    + "|Only|Positive|Negative|Level|Exact";

    private static final String AFTER =
            "by|in|at|on|of|to|for|from|with|without|as|when|where|while|only|once|until|unless|so"
                    + "|too|not|what|how|if|after|before|than|that|further|whenever|under|level"
                    + "|along|alone|away|also|behind|out|over|else|but|now";

    /** Names of a colour, and words that do stand at the beginning of a sentence. */
    private static final String FINE = "Called\\b|Red\\b|Need|Speed\\b|Right:|Wrong:";

    /** Leaves to the comment before it what the thing is. */
    private static final String SAME = "(?:The|Does the) same";

    private static final Pattern FRAGMENT =
            Pattern.compile(
                    SAME
                            + "\\b.*|(?!"
                            + FINE
                            + ")(?:(?:"
                            + LEANING.replace(' ', '|')
                            + ")\\b(?!-).*|(?:"
                            + BARE
                            + ")(?: (?:"
                            + AFTER
                            + ")\\b|[.,:;]).*|\\S+\\.)");

    private static final Pattern COMMENT =
            Pattern.compile("^[ \\t]*/\\*\\*(?!/)(.*?)\\*/", Pattern.DOTALL | Pattern.MULTILINE);

    private static final Pattern LINE_START = Pattern.compile("\\n[ \\t]*\\*?[ \\t]?");
    private static final Pattern NEXT_PART =
            Pattern.compile("<(?:p|ul|ol|pre)>|(?:^| )@(?:param|return|throws)\\b");
    private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.!?])(?= +\\P{Ll}|$)");

    /** The openings of all doc comments in a file; a comment of tags alone has none. */
    static List<DocOpening> in(Path file) {
        String name = Repository.root().relativize(file).toString();
        return in(name, Repository.text(file));
    }

    static List<DocOpening> in(String name, String text) {
        var openings = new ArrayList<DocOpening>();
        var comment = COMMENT.matcher(text);
        int line = 1;
        int counted = 0;
        while (comment.find()) {
            for (; counted < comment.start(); counted++) if (text.charAt(counted) == '\n') line++;
            String words = LINE_START.matcher(comment.group(1)).replaceAll(" ").strip();
            String sentence = SENTENCE_END.split(NEXT_PART.split(words, 2)[0].strip(), 2)[0];
            if (!sentence.isEmpty()) openings.add(new DocOpening(name + ":" + line, sentence));
        }
        return openings;
    }

    boolean isFragment() {
        return FRAGMENT.matcher(sentence).matches();
    }

    @Override
    public String toString() {
        return place + ": " + sentence;
    }
}
