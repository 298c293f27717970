package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Setting;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the README's commands are for a POSIX shell")
@ExtendWith(FreshCopy.Provider.class)
class ReadmeTest {
    private static final Pattern BLOCK = Pattern.compile("(?m)^```sh\\R(.*?)^```", Pattern.DOTALL);
    private static final Pattern SCENE_FILE =
            Pattern.compile("(?m)^```json\\R(.*?)^```", Pattern.DOTALL);
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)[^)]*\\)");

    /** They open a window, are this very test run, or serve until stopped: tested elsewhere. */
    private static final Set<String> TRIED_ELSEWHERE =
            Set.of("./lab", "./mvnw verify", "./lab grader serve --data course");

    @Test
    void everyCommandWorks(FreshCopy copy) {
        var commands = commands();
        assertTrue(commands.containsAll(TRIED_ELSEWHERE), "README lacks one of " + TRIED_ELSEWHERE);
        for (var command : commands) {
            if (TRIED_ELSEWHERE.contains(command)) continue;
            var run =
                    ChildProcess.run(
                            copy.folder(),
                            FreshCopy.withJava(),
                            Duration.ofMinutes(8),
                            List.of("sh", "-c", command));
            assertEquals(0, run.exit(), command + "\n" + run.out() + run.err());
        }
    }

    @Test
    void everyLinkLeadsSomewhere() {
        var broken = new ArrayList<String>();
        var links = LINK.matcher(readme());
        while (links.find()) {
            var target = links.group(1);
            if (!target.startsWith("http") && !Files.exists(Repository.root().resolve(target)))
                broken.add(target);
        }
        assertEquals(List.of(), broken);
    }

    @Test
    void theSceneFileIsReadAndSaysEverything() {
        var block = SCENE_FILE.matcher(readme());
        assertTrue(block.find(), "README shows no scene file");
        var view = (SceneView) SceneFile.read(block.group(1));
        for (var setting : Setting.all())
            assertTrue(view.settings().get(setting).isPresent(), setting + " is not shown");
    }

    private static List<String> commands() {
        var commands = new ArrayList<String>();
        var blocks = BLOCK.matcher(readme());
        while (blocks.find())
            for (var line : blocks.group(1).split("\\R"))
                if (!line.isBlank()) commands.add(line.replaceFirst("\\s+#.*", "").strip());
        return commands;
    }

    private static String readme() {
        return Repository.text(Repository.root().resolve("README.md"));
    }

    @Test
    void commandsOfTheReadmeAreListedByHelp(FreshCopy copy) {
        var help = copy.lab(copy.folder(), Duration.ofMinutes(1), "help").out();
        for (var command : commands()) {
            var words = command.split("\\s+");
            var at = List.of(words).indexOf("./lab");
            if (at >= 0 && words.length > at + 1)
                assertTrue(help.contains(words[at + 1]), "help does not list " + words[at + 1]);
        }
    }
}
