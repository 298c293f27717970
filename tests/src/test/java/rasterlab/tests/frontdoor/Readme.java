package rasterlab.tests.frontdoor;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import rasterlab.tests.Repository;

/** What the README and CONTRIBUTING.md say. */
final class Readme {
    private static final Pattern BLOCK = Pattern.compile("(?m)^```sh\\R(.*?)^```", Pattern.DOTALL);

    private Readme() {}

    static String text() {
        return Repository.text(Repository.root().resolve("README.md"));
    }

    /** The lines of its blocks for a shell, without what they say after a #. */
    static List<String> commands() {
        return commands(text());
    }

    /** The same of another text. */
    static List<String> commands(String text) {
        var commands = new ArrayList<String>();
        var blocks = BLOCK.matcher(text);
        while (blocks.find())
            for (var line : blocks.group(1).split("\\R"))
                if (!line.isBlank()) commands.add(line.replaceFirst("\\s+#.*", "").strip());
        return commands;
    }
}
