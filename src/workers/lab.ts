import './measuring.ts';
