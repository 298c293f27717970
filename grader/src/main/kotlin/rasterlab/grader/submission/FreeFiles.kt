package rasterlab.grader.submission

import com.sun.management.UnixOperatingSystemMXBean
import java.lang.management.ManagementFactory

/** Looks whether this process may open as many more files as an attempt to grade needs. */
object FreeFiles {
    /** The pipes of the processes that one attempt starts, and files that are read meanwhile. */
    private const val NEEDED = 12

    fun areLeft(): Boolean {
        val system = ManagementFactory.getOperatingSystemMXBean() as? UnixOperatingSystemMXBean ?: return true
        return try {
            system.maxFileDescriptorCount - system.openFileDescriptorCount >= NEEDED
        } catch (uncounted: InternalError) {
            // Counting takes a file itself.
            false
        }
    }
}
