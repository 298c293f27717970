package rasterlab.exercises.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class TexCommandsTest {
    /** The test loads classes of its own, as in a process that has set no formula yet. */
    @Test
    void aMacroIsKnownThoughItIsTheFirstCommandThatIsLookedAt() throws Exception {
        List<URL> places = new ArrayList<>();
        for (String part : System.getProperty("java.class.path").split(File.pathSeparator))
            places.add(Path.of(part).toUri().toURL());
        try (var loader =
                new URLClassLoader(
                        places.toArray(URL[]::new), ClassLoader.getPlatformClassLoader())) {
            var arguments =
                    loader.loadClass(TexCommands.class.getName())
                            .getDeclaredMethod("arguments", String.class);
            arguments.setAccessible(true);
            assertEquals(1, arguments.invoke(null, "sqrt"));
        }
    }
}
