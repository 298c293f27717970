package rasterlab.app.cli.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.opengl.state.Setting;

/** The settings of the tab OpenGL and their options, as help lists them. */
final class OpenGlSettings {
    /** Characters of a line. */
    private static final int WIDTH = 98;

    private OpenGlSettings() {}

    /** A setting's options follow its name; what does not fit stands below them. */
    static List<String> lines() {
        int column =
                Arrays.stream(Setting.values())
                                .mapToInt(each -> each.code().length())
                                .max()
                                .getAsInt()
                        + 4;
        var lines = new ArrayList<String>();
        for (Setting setting : Setting.values()) {
            var line = new StringBuilder(padded("  " + setting.code(), column));
            List<String> options = setting.options();
            for (int i = 0; i < options.size(); i++) {
                String option = options.get(i) + (i < options.size() - 1 ? ", " : "");
                if (line.length() + option.strip().length() > WIDTH) {
                    lines.add(line.toString().stripTrailing());
                    line = new StringBuilder(padded("", column));
                }
                line.append(option);
            }
            lines.add(line.toString());
        }
        return lines;
    }

    private static String padded(String text, int length) {
        return text + " ".repeat(length - text.length());
    }
}
