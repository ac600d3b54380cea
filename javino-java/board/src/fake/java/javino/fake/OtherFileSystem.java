package javino.fake;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.AccessMode;
import java.nio.file.CopyOption;
import java.nio.file.DirectoryStream;
import java.nio.file.FileStore;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.LinkOption;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.StandardOpenOption;
import java.nio.file.WatchService;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipalLookupService;
import java.nio.file.spi.FileSystemProvider;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** The computer's own files, as on another disk. */
public final class OtherFileSystem extends FileSystem {

    private static final FileSystem REAL = FileSystems.getDefault();
    private static final FileSystemProvider FILES = REAL.provider();

    private final FileSystemProvider provider = new Provider();
    private final boolean hasPermissions;
    private final Consumer<Path> created;

    private OtherFileSystem(boolean hasPermissions, Consumer<Path> created) {
        this.hasPermissions = hasPermissions;
        this.created = created;
    }

    /** A stick: all may read and write each file, and changes of permissions do nothing. */
    public static OtherFileSystem stick() {
        return new OtherFileSystem(false, file -> {});
    }

    /** One that does something as soon as a new file was opened, as another program could. */
    public static OtherFileSystem watched(Consumer<Path> created) {
        return new OtherFileSystem(true, created);
    }

    /** A path that is of this file system. */
    private interface Wrapped {
        Path real();
    }

    /** The same file, as this file system shows it. */
    public Path of(Path real) {
        return (Path) Proxy.newProxyInstance(getClass().getClassLoader(), new Class<?>[] {Path.class, Wrapped.class},
                (proxy, method, arguments) -> onPath(real, method, arguments));
    }

    private Object onPath(Path real, Method method, Object[] arguments) throws Throwable {
        if (method.getName().equals("real")) {
            return real;
        }
        if (method.getName().equals("getFileSystem")) {
            return this;
        }
        Object result = call(real, method, arguments);
        return result instanceof Path path ? of(path) : result;
    }

    private static Object call(Object on, Method method, Object[] arguments) throws Throwable {
        try {
            return method.invoke(on, arguments == null ? null
                    : Arrays.stream(arguments).map(each -> each instanceof Path path ? real(path) : each).toArray());
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private static Path real(Path path) {
        return path instanceof Wrapped wrapped ? wrapped.real() : path;
    }

    /** The same attributes, but for permissions. */
    private static Object opened(Object attributes) {
        return Proxy.newProxyInstance(OtherFileSystem.class.getClassLoader(),
                new Class<?>[] {PosixFileAttributes.class},
                (proxy, method, arguments) -> method.getName().equals("permissions")
                        ? new HashSet<>(PosixFilePermissions.fromString("rwxrwxrwx"))
                        : call(attributes, method, arguments));
    }

    private static Object onView(FileAttributeView real, Method method, Object[] arguments) throws Throwable {
        return switch (method.getName()) {
            case "readAttributes" -> opened(call(real, method, arguments));
            case "setPermissions" -> null;
            default -> call(real, method, arguments);
        };
    }

    @Override
    public FileSystemProvider provider() {
        return provider;
    }

    @Override
    public void close() {
        // The computer's stays open.
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    @Override
    public boolean isReadOnly() {
        return false;
    }

    @Override
    public String getSeparator() {
        return REAL.getSeparator();
    }

    @Override
    public Iterable<Path> getRootDirectories() {
        return REAL.getRootDirectories();
    }

    @Override
    public Iterable<FileStore> getFileStores() {
        return REAL.getFileStores();
    }

    @Override
    public Set<String> supportedFileAttributeViews() {
        return REAL.supportedFileAttributeViews();
    }

    @Override
    public Path getPath(String first, String... more) {
        return of(REAL.getPath(first, more));
    }

    @Override
    public PathMatcher getPathMatcher(String pattern) {
        return REAL.getPathMatcher(pattern);
    }

    @Override
    public UserPrincipalLookupService getUserPrincipalLookupService() {
        return REAL.getUserPrincipalLookupService();
    }

    @Override
    public WatchService newWatchService() throws IOException {
        return REAL.newWatchService();
    }

    private final class Provider extends FileSystemProvider {

        @Override
        public String getScheme() {
            return "stick";
        }

        @Override
        public FileSystem newFileSystem(URI uri, Map<String, ?> environment) {
            return OtherFileSystem.this;
        }

        @Override
        public FileSystem getFileSystem(URI uri) {
            return OtherFileSystem.this;
        }

        @Override
        public Path getPath(URI uri) {
            return of(FILES.getPath(uri));
        }

        @Override
        public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options,
                FileAttribute<?>... attributes) throws IOException {
            FileChannel opened = FILES.newFileChannel(real(path), options, attributes);
            if (options.contains(StandardOpenOption.CREATE_NEW)) {
                created.accept(real(path));
            }
            return opened;
        }

        @Override
        public SeekableByteChannel newByteChannel(Path path, Set<? extends OpenOption> options,
                FileAttribute<?>... attributes) throws IOException {
            return FILES.newByteChannel(real(path), options, attributes);
        }

        @Override
        public DirectoryStream<Path> newDirectoryStream(Path folder, DirectoryStream.Filter<? super Path> filter)
                throws IOException {
            return FILES.newDirectoryStream(real(folder), filter);
        }

        @Override
        public void createDirectory(Path folder, FileAttribute<?>... attributes) throws IOException {
            FILES.createDirectory(real(folder), attributes);
        }

        @Override
        public void delete(Path path) throws IOException {
            FILES.delete(real(path));
        }

        @Override
        public void copy(Path from, Path to, CopyOption... options) throws IOException {
            FILES.copy(real(from), real(to), options);
        }

        @Override
        public void move(Path from, Path to, CopyOption... options) throws IOException {
            FILES.move(real(from), real(to), options);
        }

        @Override
        public boolean isSameFile(Path path, Path other) throws IOException {
            return FILES.isSameFile(real(path), real(other));
        }

        @Override
        public boolean isHidden(Path path) throws IOException {
            return FILES.isHidden(real(path));
        }

        @Override
        public FileStore getFileStore(Path path) throws IOException {
            return FILES.getFileStore(real(path));
        }

        @Override
        public void checkAccess(Path path, AccessMode... modes) throws IOException {
            FILES.checkAccess(real(path), modes);
        }

        @Override
        public <V extends FileAttributeView> V getFileAttributeView(Path path, Class<V> type, LinkOption... options) {
            V view = FILES.getFileAttributeView(real(path), type, options);
            return hasPermissions || type != PosixFileAttributeView.class ? view
                    : type.cast(Proxy.newProxyInstance(getClass().getClassLoader(), new Class<?>[] {type},
                            (proxy, method, arguments) -> onView(view, method, arguments)));
        }

        @Override
        public <A extends BasicFileAttributes> A readAttributes(Path path, Class<A> type, LinkOption... options)
                throws IOException {
            A attributes = FILES.readAttributes(real(path), type, options);
            return hasPermissions || type != PosixFileAttributes.class ? attributes : type.cast(opened(attributes));
        }

        @Override
        public Map<String, Object> readAttributes(Path path, String attributes, LinkOption... options)
                throws IOException {
            return FILES.readAttributes(real(path), attributes, options);
        }

        @Override
        public void setAttribute(Path path, String attribute, Object value, LinkOption... options)
                throws IOException {
            FILES.setAttribute(real(path), attribute, value, options);
        }
    }
}
