package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Setting;
import rasterlab.tests.Repository;

class ReadmeTest {
    private static final Pattern SCENE_FILE =
            Pattern.compile("(?m)^```json\\R(.*?)^```", Pattern.DOTALL);
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)[^)]*\\)");

    @Test
    void everyLinkLeadsSomewhere() {
        var broken = new ArrayList<String>();
        var links = LINK.matcher(Readme.text());
        while (links.find()) {
            var target = links.group(1);
            if (!target.startsWith("http") && !Files.exists(Repository.root().resolve(target)))
                broken.add(target);
        }
        assertEquals(List.of(), broken);
    }

    @Test
    void theSceneFileIsReadAndSaysEverything() {
        var block = SCENE_FILE.matcher(Readme.text());
        assertTrue(block.find(), "README shows no scene file");
        var view = (SceneView) SceneFile.read(block.group(1));
        for (var setting : Setting.all())
            assertTrue(view.settings().get(setting).isPresent(), setting + " is not shown");
    }
}
